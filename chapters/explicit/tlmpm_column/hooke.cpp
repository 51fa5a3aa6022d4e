#include "chapters/material/hooke.hpp"

#include "chapters/explicit/tlmpm_column/column.hpp"

namespace mpm {

Assembled hooke_column(const ColumnSettings& settings, int cells) { return tlmpm_column<Hooke>(settings, cells); }

}  // namespace mpm
