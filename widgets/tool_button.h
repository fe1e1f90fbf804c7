// What tool rows are made of: big enough to hit, reached by Tab, named for screen readers.
#pragma once

#include <QLineEdit>
#include <QToolButton>

namespace usar::widgets {

/// `help` is tooltip and accessible name; `icon_name` as in icons.h, or empty where the button gets a text. Owned by
/// `parent`.
QToolButton* makeToolButton(const QString& help, QWidget* parent, const QString& icon_name = {});

/// The line that filters what is below it; `words` say over what ("Filter sensors"). Owned by `parent`.
QLineEdit* makeSearchLine(const QString& words, const QString& help, QWidget* parent);

} // namespace usar::widgets
