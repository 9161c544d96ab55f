# Installs BUILD into WORK/prefix, moves that elsewhere, and builds and runs tests/install/consumer against it. Then
# configures the consumer with SOURCE as a part of it.
cmake_minimum_required(VERSION 3.25)

function(run)
    execute_process(COMMAND ${ARGV} RESULT_VARIABLE result OUTPUT_VARIABLE output ERROR_VARIABLE output)
    if(NOT result EQUAL 0)
        list(JOIN ARGV " " command)
        message(FATAL_ERROR "${command}\nfailed with ${result}:\n${output}")
    endif()
    set(output "${output}" PARENT_SCOPE)
endfunction()

file(REMOVE_RECURSE ${WORK}/prefix ${WORK}/moved ${WORK}/consumer)
run(${CMAKE_COMMAND} --install ${BUILD} --prefix ${WORK}/prefix)
file(RENAME ${WORK}/prefix ${WORK}/moved)

# Nothing installed knows where it was built.
file(GLOB_RECURSE installed ${WORK}/moved/*)
if(NOT installed)
    message(FATAL_ERROR "nothing was installed into ${WORK}/prefix")
endif()
foreach(file ${installed})
    foreach(folder ${SOURCE} ${BUILD})
        execute_process(COMMAND grep -c -a -F ${folder}/ ${file} OUTPUT_VARIABLE count OUTPUT_STRIP_TRAILING_WHITESPACE)
        if(NOT count EQUAL 0)
            message(SEND_ERROR "${file} names ${folder} in ${count} lines")
        endif()
    endforeach()
endforeach()

run(${CMAKE_COMMAND} -G Ninja -S ${CMAKE_CURRENT_LIST_DIR}/consumer -B ${WORK}/consumer -DCMAKE_PREFIX_PATH=${WORK}/moved
    -DCMAKE_C_COMPILER=${COMPILER})
run(${CMAKE_COMMAND} --build ${WORK}/consumer)
run(${WORK}/consumer/consumer)
message("${output}")

# Only configured: to build it would take minutes.
file(REMOVE_RECURSE ${WORK}/parent)
run(${CMAKE_COMMAND} -G Ninja -S ${CMAKE_CURRENT_LIST_DIR}/consumer -B ${WORK}/parent -DRUBBLE_SOURCE=${SOURCE}
    -DCMAKE_C_COMPILER=${COMPILER})
run(${CMAKE_COMMAND} --build ${WORK}/parent --target help)
foreach(wanted rubble rubble-vdb)
    if(NOT output MATCHES "\n${wanted}: ")
        message(SEND_ERROR "expected the target ${wanted} in a project that adds Rubble, found none")
    endif()
endforeach()
foreach(unwanted sandbox test_core quick_tests rubble_scenes)
    if(output MATCHES "\n${unwanted}: ")
        message(SEND_ERROR "expected no target ${unwanted} in a project that adds Rubble, found one")
    endif()
endforeach()
