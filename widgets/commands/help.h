// What the Help menu shows: facts about the program, and explanations of what is clicked.
#pragma once

#include <QDialog>

namespace usar::widgets {

/// Makes a dialog with versions and licenses as a child of `window`. It is not modal; Escape closes it.
QDialog* makeAbout(QWidget* window);

/// Gives each part of `window` that has no explanation one for "What is this?": its tooltip, or else its accessible
/// description; docks get that of their contents. Parts without any show that of the part around them. To be called
/// again before each question, because tooltips change.
void explainParts(QWidget& window);

} // namespace usar::widgets
