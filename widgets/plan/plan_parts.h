// Functions that make the small parts that the widgets of plans share, with the roles of the style sheet.
#pragma once

#include <QFormLayout>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>

namespace usar::widgets {

/// A label that wraps its words. `role` is one of the style sheet: "title", "muted", "danger", …; empty: normal text.
/// Owned by `parent`, as everything here.
QLabel* makeLabel(QWidget* parent, const char* role = "", const QString& text = {});
/// Gives a widget another role; a visible one changes its colors at once.
void changeRole(QWidget* widget, const QString& role);
/// The layout of a widget whose parts are below each other, without a margin.
QVBoxLayout* makeColumn(QWidget* parent);
/// Adds OK and Cancel as the last row of a dialog and connects them. Returns OK.
QPushButton* addDialogButtons(QFormLayout* form);

} // namespace usar::widgets
