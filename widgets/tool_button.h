// The flat button of tool rows: big enough to hit, reached by Tab, named for screen readers.
#pragma once

#include <QToolButton>

namespace usar::widgets {

/// `help` is tooltip and accessible name; `icon_name` as in icons.h, or empty where the button gets a text. Owned by
/// `parent`.
QToolButton* makeToolButton(const QString& help, QWidget* parent, const QString& icon_name = {});

} // namespace usar::widgets
