#include "widgets/messages/type_choice_button.h"

#include <QPushButton>
#include <QSignalBlocker>

#include "widgets/style/form_parts.h"
#include "widgets/style/theme.h"

namespace usar::widgets {

namespace {

constexpr int most_types = 300; ///< limit of the list, because a faulty server may send any number of types
constexpr int type_role = Qt::UserRole;

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

} // namespace usar::widgets
