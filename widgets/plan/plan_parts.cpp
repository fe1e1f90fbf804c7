#include "widgets/plan/plan_parts.h"

#include <QDialog>
#include <QDialogButtonBox>

namespace usar::widgets {

QLabel* makeLabel(QWidget* parent, const char* role, const QString& text) {
    auto* label = new QLabel(text, parent);
    label->setProperty("role", role);
    label->setWordWrap(true);
    return label;
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
