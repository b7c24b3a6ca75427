# Manual page and completions, from the program's own options, made with the program: who builds it alone can install it.
# What libraries leak is the business of tests.
function(limn_describe what file)
  add_custom_command(TARGET limn POST_BUILD VERBATIM BYPRODUCTS ${file}
    COMMAND ${CMAKE_COMMAND} -E env ASAN_OPTIONS=detect_leaks=0 ${CMAKE_CROSSCOMPILING_EMULATOR} $<TARGET_FILE:limn>
            describe ${what} ${ARGN} > ${file})
endfunction()
set(described ${CMAKE_CURRENT_BINARY_DIR}/packaging)
limn_describe(man ${described}/limn.1 --date ${LIMN_DATE})
add_custom_command(TARGET limn POST_BUILD VERBATIM BYPRODUCTS ${described}/limn.1.gz
  COMMAND gzip -9nc ${described}/limn.1 > ${described}/limn.1.gz)
limn_describe(bash ${described}/limn.bash)
limn_describe(fish ${described}/limn.fish)
limn_describe(zsh ${described}/_limn)
install(FILES ${described}/limn.1.gz DESTINATION share/man/man1)
install(FILES ${described}/limn.bash DESTINATION share/bash-completion/completions RENAME limn)
install(FILES ${described}/limn.fish DESTINATION share/fish/vendor_completions.d)
install(FILES ${described}/_limn DESTINATION share/zsh/$<IF:$<BOOL:${LIMN_DEBIAN}>,vendor-completions,site-functions>)
