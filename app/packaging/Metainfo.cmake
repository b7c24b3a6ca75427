# Fills the places of org.limn.Limn.metainfo.xml.in.

# The releases that CHANGELOG.md names, as AppStream tells them; one that is not out yet has the day of its sources.
function(limn_releases result)
  file(STRINGS ${CMAKE_SOURCE_DIR}/CHANGELOG.md headings REGEX "^## [0-9.]+ \\(.*\\)$")
  set(text "")
  foreach(heading IN LISTS headings)
    string(REGEX REPLACE "^## ([0-9.]+) \\((.*)\\)$" "\\1;\\2" words "${heading}")
    list(GET words 0 version)
    list(GET words 1 date)
    set(type stable)
    if(date STREQUAL "unreleased")
      set(type development)
      set(date ${LIMN_DATE})
    endif()
    string(APPEND text "    <release version=\"${version}\" type=\"${type}\" date=\"${date}\"/>\n")
  endforeach()
  if(NOT text MATCHES "version=\"${PROJECT_VERSION}\"")
    message(FATAL_ERROR "CHANGELOG.md has no heading for ${PROJECT_VERSION}, such as: ## ${PROJECT_VERSION} (unreleased)")
  endif()
  set(${result} "${text}" PARENT_SCOPE)
endfunction()

# Links need an address on the web; without one there are none, rather than some that lead nowhere.
function(limn_addresses result)
  if(NOT LIMN_HOMEPAGE)
    set(${result} "" PARENT_SCOPE)
    return()
  endif()
  set(${result} "  <url type=\"homepage\">${LIMN_HOMEPAGE}</url>
  <screenshots>
    <screenshot type=\"default\">
      <caption>A CT head, classic left, enhanced right, the transfer function below</caption>
      <caption xml:lang=\"de\">Ein CT-Kopf, klassisch links, verstärkt rechts, darunter die Transferfunktion</caption>
      <image>${LIMN_HOMEPAGE}/app/guide/window.png</image>
    </screenshot>
    <screenshot>
      <caption>Three slices beside the picture, tinted by the curve</caption>
      <caption xml:lang=\"de\">Drei Schichten neben dem Bild, gefärbt nach der Kurve</caption>
      <image>${LIMN_HOMEPAGE}/app/guide/slices.png</image>
    </screenshot>
  </screenshots>
" PARENT_SCOPE)
endfunction()

function(limn_metainfo file)
  limn_releases(LIMN_RELEASES)
  limn_addresses(LIMN_ADDRESSES)
  configure_file(${CMAKE_CURRENT_SOURCE_DIR}/org.limn.Limn.metainfo.xml.in ${file} @ONLY)
endfunction()
