#include "widgets/bars/stop_button.h"

#include "widgets/style/icons.h"
#include "widgets/style/theme.h"

namespace usar::widgets {

StopButton::StopButton(QWidget* parent) : QPushButton(tr("STOP ALL"), parent) {
    setProperty("role", "stop");
    setIcon(widgets::icon(QStringLiteral("stop"), tokens().on_fill));
    setAccessibleName(tr("Stop all robots"));
    setToolTip(tr("Stops every robot at once (Esc twice)"));
}

} // namespace usar::widgets
