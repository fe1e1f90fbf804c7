#include "widgets/stop_button.h"

#include "widgets/icons.h"
#include "widgets/theme.h"

namespace usar::widgets {

StopButton::StopButton(QWidget* parent) : QPushButton(tr("STOP ALL"), parent) {
    setProperty("role", "stop");
    setIcon(widgets::icon(QStringLiteral("stop"), tokens().on_fill));
    setAccessibleName(tr("Stop all robots"));
    setToolTip(tr("Stops every robot at once (Esc twice)"));
}

} // namespace usar::widgets
