#include "chapters/material/neo_hookean.hpp"

#include "chapters/explicit/tlmpm_column/column.hpp"

namespace mpm {

Assembled neo_hookean_column(const ColumnSettings& settings, int cells) { return tlmpm_column<NeoHookean>(settings, cells); }

}  // namespace mpm
