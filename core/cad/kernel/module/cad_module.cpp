#include "core/cad/kernel/cad_module.hpp"

#include "core/cad/kernel/opencascade/kernel.hpp"

extern "C" __attribute__((visibility("default"))) const hariko::CadModule* hariko_cad_module() {
  static constexpr hariko::CadModule table{&hariko::by_opencascade::make_cad_file,
                                           &hariko::by_opencascade::read_cad_file};
  return &table;
}
