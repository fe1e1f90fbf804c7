#include "widgets/messages/message_filter_bar.h"

#include "widgets/style/form_parts.h"
#include "widgets/style/theme.h"
#include "widgets/style/tool_button.h"

namespace usar::widgets {

namespace {

const char* const search_help = QT_TRANSLATE_NOOP(
    "usar::widgets::MessageFilterBar",
    "Shows only lines whose type, text or reason contains this; /words between slashes/ are a regular expression");

} // namespace

MessageFilterBar::MessageFilterBar(QAction* only_trouble, QWidget* parent)
    : QWidget(parent)
    , search_(makeSearchLine(tr("Search type or text"), tr(search_help), this))
    , name_(makeSearchLine(tr("Name"), tr("Shows only lines about sensors, effecters or packages of this name"), this))
    , only_trouble_(only_trouble) {
    name_->setObjectName(QStringLiteral("name"));
    search_->setObjectName(QStringLiteral("search"));
    way_->addItems({tr("In and out"), tr("← in"), tr("→ out")});
    const QString help = tr("Lines from the server, lines sent to it, or both");
    named(way_, help, help);
    way_->setMinimumHeight(minimum_target);
    search_->setMinimumWidth(90);
    name_->setMinimumWidth(70);
    laidOut(row_, {gap::tiny, gap::tiny, gap::tiny, gap::tiny}, gap::tiny, {search_, name_, types_, way_});
    row_->setStretchFactor(search_, 3);
    row_->setStretchFactor(name_, 1);
    addButton(only_trouble);
    const auto changed = [this] {
        showExpression();
        if (!setting_)
            emit filterChanged();
    };
    connect(search_, &QLineEdit::textChanged, this, changed);
    connect(name_, &QLineEdit::textChanged, this, changed);
    connect(types_, &TypeChoiceButton::choiceChanged, this, changed);
    connect(way_, &QComboBox::currentIndexChanged, this, changed);
    connect(only_trouble, &QAction::toggled, this, changed);
}

void MessageFilterBar::addButton(QAction* action) {
    QToolButton* button = makeToolButton(action->toolTip(), this);
    button->setDefaultAction(action);
    row_->addWidget(button);
}

QString MessageFilterBar::validWords() const {
    const QString words = search_->text().trimmed();
    const auto expression = expressionOf(words);
    return expression && !expression->isValid() ? QString() : words;
}

MessageFilter MessageFilterBar::filter() const {
    MessageFilter filter;
    filter.words = validWords();
    filter.name = name_->text().trimmed();
    filter.types = types_->choice();
    filter.only_trouble = only_trouble_->isChecked();
    if (way_->currentIndex() > 0)
        filter.direction = way_->currentIndex() == 1 ? Direction::In : Direction::Out;
    return filter;
}

void MessageFilterBar::setFilter(const MessageFilter& filter) {
    setting_ = true;
    search_->setText(filter.words);
    name_->setText(filter.name);
    types_->setChoice(filter.types);
    only_trouble_->setChecked(filter.only_trouble);
    way_->setCurrentIndex(!filter.direction ? 0 : *filter.direction == Direction::In ? 1 : 2);
    setting_ = false;
    emit filterChanged();
}

void MessageFilterBar::focusSearch() {
    search_->setFocus(Qt::ShortcutFocusReason);
    search_->selectAll();
}

void MessageFilterBar::showExpression() {
    const auto expression = expressionOf(search_->text().trimmed());
    const bool wrong = expression && !expression->isValid();
    QPalette palette;
    if (wrong)
        palette.setColor(QPalette::Text, tokens().danger);
    search_->setPalette(palette);
    search_->setToolTip(
        wrong ? tr("Invalid regular expression at column %1: %2. All lines are shown until you correct it.")
                    .arg(expression->patternErrorOffset() + 2)
                    .arg(expression->errorString())
              : tr(search_help));
}

} // namespace usar::widgets
