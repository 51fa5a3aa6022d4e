# Tests of the house itself: floors, weights of programs, and what must not compile.
set(house ${CMAKE_SOURCE_DIR}/tests/house)
get_target_property(eigen_folder Eigen3::Eigen INTERFACE_INCLUDE_DIRECTORIES)
set(compile ${CMAKE_CXX_COMPILER} -std=c++20 -I ${CMAKE_SOURCE_DIR} -isystem ${eigen_folder})

add_test(NAME house.floors COMMAND sh ${house}/floors.sh ${CMAKE_SOURCE_DIR})
foreach(program usl_bar usf_bar musl_bar tlmpm_bar)
  add_test(NAME house.light.${program}
           COMMAND sh ${house}/light.sh $<TARGET_FILE:${program}> ${CMAKE_SOURCE_DIR}/chapters/explicit/${program}.cpp ${compile})
endforeach()

# Only programs that make meshes may link the target `mesh` (CGAL, GPL), and fill_demo `image` (libpng).
get_property(programs GLOBAL PROPERTY mpm_programs)
list(REMOVE_ITEM programs fill_demo cpdi_polygon_column cpdi_cylinder cpdi_two_disks)
list(TRANSFORM programs REPLACE "(.+)" "$<TARGET_FILE:\\1>")
add_test(NAME house.links COMMAND sh ${house}/links.sh ${programs} $<TARGET_FILE:compare> $<TARGET_FILE:stability>)

# Each file of tests/must_not_compile says in a line "// must say: REGEX" what a student must be able to read in the compiler's error (g++ in
# English). Those without such a line are controls, which compile.
file(GLOB sources CONFIGURE_DEPENDS ${CMAKE_SOURCE_DIR}/tests/must_not_compile/*.cpp)
foreach(source ${sources})
  get_filename_component(name ${source} NAME_WE)
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${source})
  file(STRINGS ${source} message REGEX "^// must say: ")
  add_test(NAME must_not_compile.${name} COMMAND ${compile} -fsyntax-only ${source})
  set_tests_properties(must_not_compile.${name} PROPERTIES ENVIRONMENT LC_ALL=C)  # plain quotes
  if(message)
    string(REPLACE "// must say: " "" message "${message}")
    set_tests_properties(must_not_compile.${name} PROPERTIES PASS_REGULAR_EXPRESSION "error: [^\n]*${message}")
  endif()
endforeach()
