# Converts one --help text to one man page. Variables: name (of the page, such as sightline-draw-exact), parent (the page of the
# command above it, or empty), version.
#
# The help consists of a description; "Usage: ..."; sections, each a line "Title:" with indented lines below it; paragraphs. A
# section's
# line "  term   text" is an entry, and deeper lines continue it; in "Examples:" a line at two spaces is a command, and deeper
# lines
# describe it.

# Escapes what roff would interpret. Hyphens stay hyphens, so that options can be copied from the page.
function escaped(text) {
  gsub(/\\/, "\\e", text)
  gsub(/-/, "\\-", text)
  gsub(/'/, "\\(aq", text)
  gsub(/\^/, "\\(ha", text)
  gsub(/~/, "\\(ti", text)
  sub(/^\./, "\\\\\\&.", text)
  return text
}

# Words in `backquotes` become bold.
function prose(text,    at, result) {
  text = escaped(text)
  result = bold ? "\\fB" : ""
  while ((at = index(text, "`")) > 0) {
    bold = !bold
    result = result substr(text, 1, at - 1) (bold ? "\\fB" : "\\fR")
    text = substr(text, at + 1)
  }
  return result text (bold ? "\\fR" : "")
}

function add(line) { section_text[title] = section_text[title] line "\n" }

function begin_section(new_title) {
  bold = 0
  title = new_title
  if (!(title in section_text)) {
    section_text[title] = ""
    order[++sections] = title
  }
}

function end_block() {
  if (in_block) add(".EE")
  in_block = 0
}

BEGIN { title = "" }

!usage && /^Usage: / {
  usage = escaped(substr($0, 8))
  begin_section("DESCRIPTION")
  next
}
usage && title == "DESCRIPTION" && !/^$/ && !described && /^  / { usage = usage " " escaped(substr($0, 3)); next }
!usage { description = description (description == "" ? "" : " ") escaped($0); next }

/^$/ { end_block(); bold = 0; described = 1; blank = NR; if (title == "DESCRIPTION") add(".PP"); next }

/^Exit codes: / { end_block(); begin_section("EXIT STATUS"); add(prose(substr($0, 13))); in_exit = 1; next }

# A section follows an empty line: its entries are indented.
blank == NR - 1 && /^[A-Z][A-Za-z ]*:$/ {
  end_block()
  in_exit = 0
  heading = toupper(substr($0, 1, length($0) - 1))
  if (heading == "SUBCOMMANDS") heading = "COMMANDS"
  begin_section(heading)
  next
}

# Prose below the sections describes the command.
/^[^ ]/ {
  end_block()
  if (in_exit) { add(prose($0)); next }
  if (title != "DESCRIPTION") begin_section("DESCRIPTION")
  if (last_prose == NR - 1) add(".PP")  # a line of the help is a paragraph
  last_prose = NR
  add(prose($0))
  next
}

title == "EXAMPLES" && /^  [^ ]/ { add(".TP"); add("\\fB" escaped(substr($0, 3)) "\\fR"); next }
title == "EXAMPLES" { sub(/^ +/, ""); add(prose($0)); next }

# Indented lines within prose are copied.
title == "DESCRIPTION" { if (!in_block) add(".EX"); in_block = 1; add(escaped($0)); next }

# An entry and its continuation.
/^  [^ ]/ {
  bold = 0
  entry = substr($0, 3)
  text = ""
  if (match(entry, /  +/)) {
    text = substr(entry, RSTART + RLENGTH)
    entry = substr(entry, 1, RSTART - 1)
  }
  add(".TP")
  add("\\fB" prose(entry) "\\fR")
  if (text != "") add(prose(text))
  next
}
{ sub(/^ +/, ""); add(prose($0)) }

END {
  end_block()
  printf ".\\\" Made from the --help of %s by tools/manual; change the help instead.\n", name
  printf ".TH %s 1 \"\" \"Sightline %s\" \"Sightline\"\n", toupper(name), version
  printf ".nh\n.ad l\n"
  sub(/^Sightline: /, "", description)
  printf ".SH NAME\n%s \\- %s\n", escaped(name), description
  printf ".SH SYNOPSIS\n.B %s\n", usage
  first = "DESCRIPTION"
  if (section_text[first] != "") write(first)
  for (i = 1; i <= sections; ++i) if (order[i] != first && order[i] != "EXIT STATUS") write(order[i])
  if ("EXIT STATUS" in section_text) write("EXIT STATUS")
  if (parent != "") printf ".SH SEE ALSO\n.BR %s (1)\n", escaped(parent)
}

function write(heading,    text) {
  text = section_text[heading]
  while (sub(/^\.PP\n/, "", text)) {}
  while (sub(/\.PP\n$/, "", text)) {}
  gsub(/(\.PP\n)+\.PP\n/, ".PP\n", text)
  if (text != "") printf ".SH %s\n%s", heading, text
}
