// Saves the drawing of a plan as a picture file.
#pragma once

#include <QString>

#include "core/base/result.h"
#include "widgets/plan/plan_view.h"

namespace usar::widgets {

/// Draws everything that is not folded, in the light theme, with the running parts and newest answers. The extension of
/// `file` selects the format: .svg, .pdf (one page as large as the drawing) or .png (twice the size on the screen, less
/// if that is too large). The file is replaced atomically. GUI thread.
Result<void> savePlanPicture(PlanView& view, const QString& file);

} // namespace usar::widgets
