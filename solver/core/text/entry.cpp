// What the host calls of this stage.
#include "text/bodies.hpp"
#include "text/yaml.hpp"

extern "C" __attribute__((export_name("bodies_text"))) i64 entry_bodies_text(u8* rows, i64 size) {
  return told(text::bodies_text({rows, size}));
}

extern "C" __attribute__((export_name("yaml_text"))) i64 entry_yaml_text(u8* json, i64 size) {
  return told(text::yaml_text({json, size}));
}
