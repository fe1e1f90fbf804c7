// Drag format between the sensor panel and the plots.
#pragma once

namespace usar::widgets {

/// UTF-8 paths of fields as protocol::Field::path() returns them, one per line.
inline constexpr const char* field_mime_type = "application/x-usar-field";

} // namespace usar::widgets
