#include "widgets/style/tool_button.h"

#include "widgets/style/form_parts.h"
#include "widgets/style/icons.h"
#include "widgets/style/theme.h"

namespace usar::widgets {

QToolButton* makeToolButton(const QString& help, QWidget* parent, const QString& icon_name) {
    auto* button = named(new QToolButton(parent), help, help);
    button->setIcon(icon(icon_name));
    makeFlat(button);
    button->setFocusPolicy(Qt::StrongFocus);
    return button;
}

QLineEdit* makeSearchLine(const QString& words, const QString& help, QWidget* parent) {
    auto* line = named(new QLineEdit(parent), words, help);
    line->setPlaceholderText(words);
    line->setClearButtonEnabled(true);
    line->setMinimumHeight(minimum_target);
    line->addAction(icon(QStringLiteral("search")), QLineEdit::LeadingPosition);
    return line;
}

} // namespace usar::widgets
