#!/usr/bin/perl
# Fails if a text of the repository has a phrase of phrases.txt.
#
#   perl check_phrases.pl PHRASES ROOT [--except=PATH]...
#
# Reads the files that git tracks or would track under ROOT, or all files if ROOT has no git, of the kinds below. A
# phrase is found as whole words in any case; between its words may be blanks, line ends, comment signs and `_`. File
# names count as text. Prints FILE:LINE, the phrase and what to write instead; exit 1 if there is any, 2 on bad input.
# Needs perl-base alone.
use strict;
use warnings;

my ($list, $root, @options) = @ARGV;
defined $root or die_badly("usage: check_phrases.pl PHRASES ROOT [--except=PATH]...");
my @except = map { /^--except=(.+?)\/?$/ ? $1 : die_badly("unknown option $_, expected --except=PATH") } @options;

sub die_badly { print STDERR "$_[0]\n"; exit 2; }

# The phrases, longest first, so that the most specific one is reported.
my (%instead, @patterns);
open(my $in, '<', $list) or die_badly("$list: $!");
while (my $row = <$in>) {
  chomp $row;
  next if $row eq '' || $row =~ /^#/;
  my ($phrase, $standard) = split /\t/, $row, -1;
  die_badly("$list:$.: expected a phrase, a tab and the standard wording")
    if !defined $standard || $standard eq '' || $phrase !~ /^[a-z_']+( [a-z_']+)*$/ || $row =~ /\t.*\t/;
  die_badly("$list:$.: \"$phrase\" is listed twice") if $instead{$phrase};
  $instead{$phrase} = $standard;
}
close $in;
die_badly("$list: no phrases") unless %instead;

# Between two words: blanks, or a line end with the comment sign of the next line, or the `_` of a name, or the quotes
# that end and begin a string literal continued on the next line.
my $gap = qr{(?:[ \t]+|_|[ \t]*"?[ \t\r]*\n[ \t]*(?:(?://|\#|;|/|\*)+[ \t]*|")?)};
for my $phrase (sort { length $b <=> length $a || $a cmp $b } keys %instead) {
  push @patterns, join $gap, map { quotemeta } split / /, $phrase;
}
my $any = join '|', @patterns;
my $found = qr{(?<![A-Za-z0-9])(?:$any)(?![A-Za-z0-9])}i;

my $listing = -e "$root/.git" ? qx(git -C "$root" ls-files --cached --others --exclude-standard)
                              : qx(cd "$root" && find . -type f | sed 's,^\\./,,' | LC_ALL=C sort);
die_badly("$root: cannot list the files") if $? != 0 || $listing eq '';
my ($read, $hits) = (0, 0);
for my $file (split /\n/, $listing) {
  next unless $file =~ /\.(?:cpp|hpp|txt|md|s|asm|json|cmake|pl|sh|bash)$|^tools\/dev$/;    # txt: CMakeLists.txt, too
  next if $file eq 'tests/layering/phrases.txt' || grep { $file eq $_ || index($file, "$_/") == 0 } @except;
  next if $file =~ m{^tests/data/i8080/|^build/};    # vectors without a word
  open(my $text, '<', "$root/$file") or next;        # deleted, but still tracked
  my $all = do { local $/; <$text> };
  close $text;
  ++$read;
  for my $part (["$file\n", 0], [$all, 1]) {
    my ($content, $inside) = @$part;
    while ($content =~ /$found/g) {
      my ($phrase, $line) = (lc $&, $inside ? 1 + (substr($content, 0, $-[0]) =~ tr/\n//) : 0);
      $phrase =~ s/[^a-z']+/ /g unless $instead{$phrase};
      print "$file:$line: \"$phrase\", write: ", $instead{$phrase} // '(see phrases.txt)', "\n";
      ++$hits;
    }
  }
}
die_badly("$root: none of the files is a text to check") if $read == 0;
print "$read files, $hits phrases of $list\n" if $hits;
exit($hits ? 1 : 0);
