#include "widgets/messages/message_filter_bar.h"

#include <QPushButton>
#include <QSignalBlocker>

#include "widgets/style/form_parts.h"
#include "widgets/style/theme.h"
#include "widgets/style/tool_button.h"

namespace usar::widgets {
namespace {

constexpr int most_types = 300; ///< limit of the list, because a faulty server may send any number of types
constexpr int type_role = Qt::UserRole;

const char* const search_help = QT_TRANSLATE_NOOP(
    "usar::widgets::MessageFilterBar",
    "Shows only lines whose type, text or reason contains this; /words between slashes/ are a regular expression");

} // namespace

TypeChoiceButton::TypeChoiceButton(QWidget* parent) : QToolButton(parent), popup_(makePopup()) {
    setToolTip(tr("Which types of lines are shown"));
    setAccessibleName(tr("Types"));
    setFocusPolicy(Qt::StrongFocus);
    setMinimumHeight(minimum_target);
    setToolButtonStyle(Qt::ToolButtonTextOnly);
    setArrowType(Qt::NoArrow);
    connect(this, &QToolButton::clicked, this, &TypeChoiceButton::openList);
    showChoice();
}

QWidget* TypeChoiceButton::makePopup() {
    auto* popup = new QFrame(this, Qt::Popup);
    popup->setFrameShape(QFrame::StyledPanel);
    auto* all = new QPushButton(tr("All"), popup);
    auto* none = new QPushButton(tr("None"), popup);
    for (QPushButton* button : {all, none})
        button->setMinimumHeight(minimum_target);
    all->setToolTip(tr("Shows all types, also those that come later"));
    none->setToolTip(tr("Shows only the types that you check from now on"));
    list_ = new QListWidget(popup);
    auto* column = laidOut(new QVBoxLayout(popup), {gap::tiny, gap::tiny, gap::tiny, gap::tiny}, gap::tiny);
    column->addLayout(laidOut(new QHBoxLayout, -1, {all, none}));
    column->addWidget(list_);
    list_->setAccessibleName(tr("Types"));
    list_->setFrameShape(QFrame::NoFrame);
    list_->setFont(codeFont());
    list_->setUniformItemSizes(true);
    connect(all, &QPushButton::clicked, this, [this] { choose({}); });
    connect(none, &QPushButton::clicked, this, [this] { choose({.types = {}, .only_these = true}); });
    connect(list_, &QListWidget::itemChanged, this, &TypeChoiceButton::takeTick);
    return popup;
}

QSize TypeChoiceButton::sizeHint() const {
    const int width = fontMetrics().horizontalAdvance(QStringLiteral("SEN RangeScan ▾")) + 2 * gap::small;
    return {width, QToolButton::sizeHint().height()};
}

void TypeChoiceButton::setChoice(const TypeChoice& choice) {
    choice_ = choice;
    showChoice();
}

void TypeChoiceButton::choose(const TypeChoice& choice) {
    if (choice == choice_)
        return;
    setChoice(choice);
    fill();
    emit choiceChanged();
}

void TypeChoiceButton::openList() {
    fill();
    constexpr int rows_shown = 14;
    const int rows = std::clamp(list_->count(), 3, rows_shown);
    list_->setFixedHeight(rows * std::max(list_->sizeHintForRow(0), minimum_target) + 2);
    list_->setMinimumWidth(list_->sizeHintForColumn(0) + 2 * gap::large);
    popup_->adjustSize();
    popup_->move(mapToGlobal(QPoint(0, height())));
    popup_->show();
    list_->setFocus();
    list_->setCurrentRow(0);
}

void TypeChoiceButton::fill() {
    const QSignalBlocker quiet(list_);
    const int current = list_->currentRow();
    list_->clear();
    Counts counts = counts_ ? counts_() : Counts();
    for (const std::string& type : choice_.types)
        counts.try_emplace(type, 0);
    for (const auto& [type, count] : counts) {
        if (list_->count() == most_types)
            break;
        const QString name = QString::fromStdString(type);
        auto* item = new QListWidgetItem(tr("%1  (%2)").arg(name).arg(count), list_);
        item->setData(type_role, name);
        item->setFlags(Qt::ItemIsEnabled | Qt::ItemIsSelectable | Qt::ItemIsUserCheckable);
        item->setCheckState(choice_.shows(type) ? Qt::Checked : Qt::Unchecked);
        item->setSizeHint(QSize(0, minimum_target));
    }
    if (list_->count() == 0)
        (new QListWidgetItem(tr("No lines yet"), list_))->setFlags(Qt::NoItemFlags);
    list_->setCurrentRow(current);
}

void TypeChoiceButton::takeTick(const QListWidgetItem* item) {
    const std::string type = item->data(type_role).toString().toStdString();
    const bool listed = (item->checkState() == Qt::Checked) == choice_.only_these;
    if (listed)
        choice_.types.insert(type);
    else
        choice_.types.erase(type);
    showChoice();
    emit choiceChanged();
}

void TypeChoiceButton::showChoice() {
    const int count = static_cast<int>(choice_.types.size());
    QString text = tr("All types");
    if (choice_.only_these)
        text = count == 1 ? QString::fromStdString(*choice_.types.begin()).left(16) : tr("%n type(s)", nullptr, count);
    else if (count > 0)
        text = tr("All but %1").arg(count);
    setText(text + QStringLiteral(" ▾"));
}

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
    search_->setMinimumWidth(60);
    name_->setMinimumWidth(50);
    types_->setMinimumWidth(60);
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

void MessageFilterBar::resizeEvent(QResizeEvent* event) {
    QWidget::resizeEvent(event);
    name_->show();
    way_->show();
    const auto tooNarrow = [this] { return row_->totalMinimumSize().width() > width(); };
    name_->setHidden(tooNarrow() && name_->text().isEmpty());
    way_->setHidden(tooNarrow() && way_->currentIndex() == 0);
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
    setRole(search_, wrong ? "danger" : "");
    search_->setToolTip(
        wrong ? tr("Invalid regular expression at column %1: %2. All lines are shown until you correct it.")
                    .arg(expression->patternErrorOffset() + 2)
                    .arg(expression->errorString())
              : tr(search_help));
}

} // namespace usar::widgets
