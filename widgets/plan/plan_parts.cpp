#include "widgets/plan/plan_parts.h"

#include <QDialog>
#include <QDialogButtonBox>
#include <QStyle>

#include "widgets/style/theme.h"

namespace usar::widgets {

QLabel* makeLabel(QWidget* parent, const char* role, const QString& text) {
    auto* label = new QLabel(text, parent);
    label->setProperty("role", role);
    label->setWordWrap(true);
    return label;
}

void changeRole(QWidget* widget, const QString& role) {
    if (widget->property("role") == role)
        return;
    widget->setProperty("role", role);
    widget->style()->unpolish(widget); // Otherwise the color of the previous role would stay.
    widget->style()->polish(widget);
}

QVBoxLayout* makeColumn(QWidget* parent) {
    auto* column = new QVBoxLayout(parent);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(gap::tiny);
    return column;
}

QPushButton* addDialogButtons(QFormLayout* form) {
    auto* dialog = qobject_cast<QDialog*>(form->parentWidget());
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel, dialog);
    form->addRow(buttons);
    QObject::connect(buttons, &QDialogButtonBox::accepted, dialog, &QDialog::accept);
    QObject::connect(buttons, &QDialogButtonBox::rejected, dialog, &QDialog::reject);
    return buttons->button(QDialogButtonBox::Ok);
}

} // namespace usar::widgets
