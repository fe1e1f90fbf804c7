// What can be done with mouse and held keys, for the sheet of shortcuts.
#pragma once

#include <utility>

#include <QList>
#include <QString>

namespace usar::widgets {

/// Pairs of a gesture and what it does.
QList<std::pair<QString, QString>> gestures();

} // namespace usar::widgets
