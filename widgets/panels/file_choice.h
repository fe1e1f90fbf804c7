// Asks the user for the file that something is saved to.
#pragma once

#include <QWidget>

namespace usar::widgets {

/// Returns `path` with `suffix` (".png") added if it has none; an empty path stays empty.
QString withSuffix(const QString& path, const QString& suffix);

/// Lets the user choose a file; empty if the user cancels. `proposal`: name or path that is offered. `filters`: as for
/// QFileDialog. A name that is typed without a suffix gets that of the chosen filter, that is, the filter's first one.
QString askWhereToSave(QWidget* parent, const QString& title, const QString& proposal, const QString& filters);

} // namespace usar::widgets
