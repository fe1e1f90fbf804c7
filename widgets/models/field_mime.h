// The drag format between sensor panel and plots.
#pragma once

namespace usar::widgets {

/// The UTF-8 paths of fields as protocol::Field::path() gives them, one a line.
inline constexpr const char* field_mime_type = "application/x-usar-field";

} // namespace usar::widgets
