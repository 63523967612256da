# prototypes.cmake -- what the kernels are called from where they are compiled once: of every KERNEL of the templates, its
# prototype in one number type, and its short word for the external name.
#
#     cmake -D KERNELS=core/kernels/kernels.tmpl.h -D ROOT=... -D SUFFIX=q -D HEADER=q.h -P prototypes.cmake
#
# The header is written only when it changes: who includes it is compiled again when a kernel is called differently, not when it
# computes differently.
file(READ ${ROOT}/${KERNELS} list)
string(REGEX MATCHALL "core/kernels/[a-z_]+.tmpl.h" templates "${list}")
set(header "/* ${SUFFIX}.h -- made from core/kernels by prototypes.cmake. */\n")
foreach(template ${templates})
  file(READ ${ROOT}/${template} text)
  string(APPEND header "\n/* ${template} */\n")
  string(REGEX REPLACE "[[]" "@<" text "${text}") # brackets would hold the elements of a list together
  string(REGEX REPLACE "[]]" "@>" text "${text}")
  string(REPLACE ";" "" text "${text}")
  string(REGEX MATCHALL "\nKERNEL [^{]+" prototypes "${text}")
  foreach(prototype ${prototypes})
    string(REGEX MATCH "G\\(([a-z0-9_]+)\\)\\(" ignored "${prototype}")
    set(kernel ${CMAKE_MATCH_1})
    string(REGEX REPLACE "^\nKERNEL " "" prototype "${prototype}")
    string(REGEX REPLACE "[ \n]+" " " prototype "${prototype}")
    string(REGEX REPLACE " $" "" prototype "${prototype}")
    string(REGEX REPLACE "(^|[ (])num " "\\1num_${SUFFIX} " prototype "${prototype}")
    string(REGEX REPLACE "G\\(([a-z0-9_]+)\\)" "\\1_${SUFFIX}" prototype "${prototype}")
    string(REPLACE "@<" "[" prototype "${prototype}")
    string(REPLACE "@>" "]" prototype "${prototype}")
    string(APPEND header "#define ${kernel}_${SUFFIX} cagd_${kernel}_${SUFFIX}\n${prototype};\n")
  endforeach()
endforeach()
file(CONFIGURE OUTPUT ${HEADER} CONTENT "${header}" @ONLY)
