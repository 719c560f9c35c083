# Converts one --help text to table rows of the bash completion. Variable: command (as it is typed).
/^[^ ]/ { listed = $0 == "Subcommands:" }
/^Options of most subcommands:$/ { exit }  # they are typed behind the name of a subcommand
listed && /^  [^ ]/ { words = words " " $1 }
/^  -/ {
  n = split($1, names, ",")
  for (i = 1; i <= n; ++i) {
    if (names[i] !~ /^--/) continue
    words = words " " names[i]
    if ($2 ~ /^\{.*\}$/) {
      values = substr($2, 2, length($2) - 2)
      gsub(/,/, " ", values)
      printf "_sightline_words[%s]=\"%s\"\n", quoted(command " " names[i]), values
    }
  }
}
END { printf "_sightline_words[%s]=\"%s\"\n", quoted(command), substr(words, 2) }

function quoted(text) { return "\"" text "\"" }
