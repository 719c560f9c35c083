
_sightline() {
  local current=${COMP_WORDS[COMP_CWORD]} previous=${COMP_WORDS[COMP_CWORD - 1]} command=sightline i
  # `help` takes the same words as the command.
  i=1
  if [[ ${COMP_WORDS[1]} == help && $COMP_CWORD -gt 1 ]]; then i=2; fi
  for ((; i < COMP_CWORD; ++i)); do
    if [[ -n ${_sightline_words["$command ${COMP_WORDS[i]}"]} && ${COMP_WORDS[i]} != -* ]]; then
      command+=" ${COMP_WORDS[i]}"
    fi
  done
  local words=${_sightline_words["$command $previous"]}
  if [[ $previous != -* || -z $words ]]; then words=${_sightline_words[$command]}; fi
  # Options are completed only after a dash; elsewhere file names are.
  if [[ $current != -* ]]; then words=$(printf '%s\n' $words | grep -v '^--'); fi
  COMPREPLY=($(compgen -W "$words" -- "$current"))
}
complete -o default -F _sightline sightline
