# Completion of `sightline` for bash: subcommands, options, and the values of options that take one of a few.
# Made from its --help by tools/manual; all other words are completed as file names.
declare -gA _sightline_words
