# SPDX-License-Identifier: MIT
# cmake -DOUTPUT=… -DROOT=… -DFILES=a,b -P embed.cmake: writes a C++ table of the files' text.
string(REPLACE "," ";" FILES "${FILES}")
set(table "")
foreach(file IN LISTS FILES)
  file(READ ${ROOT}/${file} text)
  string(APPEND table "    {\"${file}\", R\"__OPENCL__(${text})__OPENCL__\"},\n")
endforeach()
file(WRITE ${OUTPUT}
"#include \"device/kernel_source.h\"

namespace stagelight {
const std::map<std::string, std::string, std::less<>> embedded_sources = {
${table}};
}  // namespace stagelight
")
