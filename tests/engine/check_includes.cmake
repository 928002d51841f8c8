# SPDX-License-Identifier: GPL-3.0-or-later
# packaging/check-includes refuses an include against the order of the folders and names its line.
#   cmake -DCHECK=script -DWORK=folder -P check_includes.cmake

cmake_minimum_required(VERSION 3.25)

set(source "${WORK}/includes.cpp")
function(check TOP TEXT EXPECTED)
  file(WRITE "${source}" "${TEXT}")
  execute_process(COMMAND "${CHECK}" ${TOP} ${TOP}/views:${TOP}/base "${source}"
                  RESULT_VARIABLE result OUTPUT_QUIET ERROR_VARIABLE errors)
  if(EXPECTED STREQUAL "" AND NOT result EQUAL 0)
    message(SEND_ERROR "refused:\n${TEXT}${errors}")
  elseif(NOT EXPECTED STREQUAL "" AND (result EQUAL 0 OR NOT errors MATCHES "${EXPECTED}"))
    message(SEND_ERROR "exit code ${result}, \"${errors}\" and not \"${EXPECTED}\", for:\n${TEXT}")
  endif()
endfunction()

check(engine "#include <vector>\n#include \"engine/base/error.hpp\"\n" "")
check(engine "#include \"engine/views/a.hpp\"\n// #include \"engine/other/a.hpp\"\n" "")
check(engine "#include <vector>\n\n  #  include \"engine/other/a.hpp\"\n"
      "includes.cpp:3: error: includes engine/other/a.hpp, but engine/views sees no more than")
check(engine "#include \"engine/base/deeper/a.hpp\"\n" "includes.cpp:1: error")
check(engine "#include \"engine/sonde.hpp\"\n" "includes.cpp:1: error")
check(engine "#include \"ui/base/a.hpp\"\n" "includes.cpp:1: error")
check(engine "#include \"error.hpp\"\n" "includes.cpp:1: error")
check(engine "#include <unistd.h>\n" "includes.cpp:1: error: includes <unistd.h> of the system")
check(engine "#include <cerrno>\n\n# include <sys/stat.h>\n" "includes.cpp:3: error: includes <sys/stat.h>")
check(ui "#include <QSystemTrayIcon>\n#include <signal.h>\n" "includes.cpp:2: error: includes <signal.h>")
check(app "#include \"ui/other/a.hpp\"\n#include <sched.h>\n" "includes.cpp:2: error: includes <sched.h>")
check(engine/platform "#include <sched.h>\n" "")
check(ui "#include \"engine/other/a.hpp\"\n#include \"ui/base/a.hpp\"\n" "")
check(ui "#include \"engine/other/a.hpp\"\n#include \"ui/other/a.hpp\"\n" "includes.cpp:2: error")
