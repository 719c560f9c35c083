# Completion of `sightline` for bash: subcommands, options, and the values of options that take one of a few.
# Made from its --help by tools/manual; anything else is completed as a file name.
declare -gA _sightline_words
