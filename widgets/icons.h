// Icons drawn as vectors by name: crisp at any scale, in the palette's colors, no picture files.
#pragma once

#include <QIcon>
#include <QString>
#include <QStringList>

namespace usar::widgets {

/// Drawn on a 24 x 24 grid with the application palette's text color (muted when disabled, accent when on). An unknown
/// name gives a null icon; `iconNames` lists what there is.
QIcon icon(const QString& name);
/// The same in one fixed color, for icons that mean a state.
QIcon icon(const QString& name, const QColor& color);
QStringList iconNames();

} // namespace usar::widgets
