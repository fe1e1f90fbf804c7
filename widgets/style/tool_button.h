// Functions that make the parts of tool rows: large enough to click, reachable by Tab, and named for screen readers.
#pragma once

#include <QLineEdit>
#include <QToolButton>

namespace usar::widgets {

/// `help` becomes tooltip and accessible name; `icon_name` as in icons.h, empty for a button with text. Owned by
/// `parent`.
QToolButton* makeToolButton(const QString& help, QWidget* parent, const QString& icon_name = {});

/// Makes a search field; `words` is its placeholder, for example "Filter sensors". Owned by `parent`.
QLineEdit* makeSearchLine(const QString& words, const QString& help, QWidget* parent);

} // namespace usar::widgets
