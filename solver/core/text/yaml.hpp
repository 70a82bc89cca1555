// Documents as YAML, from their JSON: what is flat on one line, what is not as a block, so that readers of YAML 1.1 and 1.2 agree.
#pragma once

#include "plain/tables.hpp"

namespace text {

// UTF-8 both; ends with a line's end. What is no JSON, or is nested deeper than documents are, ends the call.
Bytes yaml_text(Bytes json);

}  // namespace text
