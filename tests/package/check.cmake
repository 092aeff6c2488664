# Installs the project to a fresh prefix, builds examples/robot_app against it and runs that on the
# shipped rawlog. Variables: BUILD_DIR, SOURCE_DIR, WORK_DIR, GENERATOR.
function(run)
    execute_process(COMMAND ${ARGV} RESULT_VARIABLE result OUTPUT_VARIABLE output ERROR_VARIABLE output)
    if(NOT result EQUAL 0)
        message(FATAL_ERROR "${ARGV}\n${output}")
    endif()
    set(run_output "${output}" PARENT_SCOPE)
endfunction()

file(REMOVE_RECURSE ${WORK_DIR})
run(${CMAKE_COMMAND} --install ${BUILD_DIR} --prefix ${WORK_DIR}/prefix)
run(${CMAKE_COMMAND} -S ${SOURCE_DIR}/examples/robot_app -B ${WORK_DIR}/build -G ${GENERATOR}
    -DCMAKE_PREFIX_PATH=${WORK_DIR}/prefix -DCMAKE_BUILD_TYPE=Release)
run(${CMAKE_COMMAND} --build ${WORK_DIR}/build)
run(${WORK_DIR}/build/robot_app ${SOURCE_DIR}/datasets/street/street.rawlog)
if(NOT run_output MATCHES "track [0-9]+ at \\(")
    message(FATAL_ERROR "robot_app saw no moving vehicle:\n${run_output}")
endif()

# A robot that meets scans out of order goes on: twice the same recording, one behind the other,
# which for gz streams is a file of its own.
set(street ${SOURCE_DIR}/datasets/street/street.rawlog)
run(sh -c "cat '${street}' '${street}' > '${WORK_DIR}/twice.rawlog'")
run(${WORK_DIR}/build/robot_app ${WORK_DIR}/twice.rawlog)
if(NOT run_output MATCHES "scan skipped: ")
    message(FATAL_ERROR "robot_app met no scan out of order:\n${run_output}")
endif()

run(${WORK_DIR}/prefix/bin/vdamf-track --version)
