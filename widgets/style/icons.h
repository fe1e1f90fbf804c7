// Icons drawn as vectors and found by name: sharp at any scale, in the palette's colors, without picture files.
#pragma once

#include <QColor>
#include <QIcon>
#include <QString>
#include <QStringList>

namespace usar::widgets {

/// Drawn on a 24 x 24 grid in the application palette's text color (muted when disabled, accent color when on). An
/// unknown name returns a null icon. A valid `color` replaces the text and accent colors, for icons that stand for a
/// state.
QIcon icon(const QString& name, const QColor& color = {});
/// The names of all icons.
QStringList iconNames();

} // namespace usar::widgets
