// The drawing of a plan as a picture in a file.
#pragma once

#include <QString>

#include "core/base/result.h"
#include "widgets/plan_view.h"

namespace usar::widgets {

/// All that is unfolded, in the light theme, with what runs and the newest answers. The ending of the name says what it
/// is: .svg, .pdf (one page as large as the drawing) or .png (twice the size on screen, less where that is too large).
/// The file is replaced at once or not at all. GUI thread.
Result<void> savePlanPicture(PlanView& view, const QString& file);

} // namespace usar::widgets
