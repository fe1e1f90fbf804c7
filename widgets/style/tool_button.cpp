#include "widgets/style/tool_button.h"

#include "widgets/style/icons.h"
#include "widgets/style/theme.h"

namespace usar::widgets {

QToolButton* makeToolButton(const QString& help, QWidget* parent, const QString& icon_name) {
    auto* button = new QToolButton(parent);
    if (!icon_name.isEmpty())
        button->setIcon(icon(icon_name));
    button->setToolTip(help);
    button->setAccessibleName(help);
    button->setAutoRaise(true);
    button->setFocusPolicy(Qt::StrongFocus);
    button->setMinimumSize(minimum_target, minimum_target);
    return button;
}

QLineEdit* makeSearchLine(const QString& words, const QString& help, QWidget* parent) {
    auto* line = new QLineEdit(parent);
    line->setPlaceholderText(words);
    line->setAccessibleName(words);
    line->setToolTip(help);
    line->setClearButtonEnabled(true);
    line->setMinimumHeight(minimum_target);
    line->addAction(icon(QStringLiteral("search")), QLineEdit::LeadingPosition);
    return line;
}

} // namespace usar::widgets
