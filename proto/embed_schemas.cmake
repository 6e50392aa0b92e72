# Writes OUTPUT, a C++ source that holds the text of every FOLDER/*.json under its name without the extension.
file(GLOB files ${FOLDER}/*.json)
list(SORT files)
set(entries "")
foreach(path IN LISTS files)
  get_filename_component(name ${path} NAME)
  string(REGEX REPLACE "\\.json$" "" name ${name})
  file(READ ${path} text)
  string(APPEND entries "    {\"${name}\", R\"schema(${text})schema\"},\n")
endforeach()
file(WRITE ${OUTPUT} "// Made from proto/schema; do not edit.
#include \"schema/schema_texts.hpp\"

namespace contactd::proto {

const std::vector<SchemaText>& schema_texts() {
    static const std::vector<SchemaText> texts{
${entries}    };
    return texts;
}

}  // namespace contactd::proto
")
