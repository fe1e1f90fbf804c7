// Functions that make the small parts that the widgets of plans share, with the roles of the style sheet.
#pragma once

#include <QFormLayout>
#include <QLabel>
#include <QPushButton>

namespace usar::widgets {

/// A label that wraps its words. `role` is one of the style sheet: "title", "muted", "danger", …; empty: normal text.
/// Owned by `parent`, as everything here.
QLabel* makeLabel(QWidget* parent, const char* role = "", const QString& text = {});
/// Adds OK and Cancel as the last row of a dialog and connects them. Returns OK.
QPushButton* addDialogButtons(QFormLayout* form);

} // namespace usar::widgets
