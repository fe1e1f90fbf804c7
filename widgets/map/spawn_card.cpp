#include "widgets/map/spawn_card.h"

#include <limits>
#include <utility>

#include <QApplication>
#include <QFormLayout>
#include <QKeyEvent>
#include <QRegularExpressionValidator>

#include "widgets/style/form_parts.h"
#include "widgets/style/icons.h"
#include "widgets/style/theme.h"

namespace usar::widgets {

namespace {
constexpr int pose_gap_px = gap::large; ///< distance from the pose to the corner that the map passes to openFor
}

SpawnCard::SpawnCard(QWidget* over) : QFrame(over) {
    setProperty("role", "card");
    setAccessibleName(tr("Spawn a robot"));
    setAutoFillBackground(true);
    title_->setProperty("role", "title");
    named(class_, tr("Robot class"), tr("The kind of robot that the server spawns"));
    named(name_, tr("Robot name"), tr("Letters, digits, - and _; every robot needs a name of its own"));
    name_->setTextMargins(2, 0, 2, 0);
    // The protocol has no quotes: a space or a brace would end the name.
    name_->setValidator(
        new QRegularExpressionValidator(QRegularExpression(QStringLiteral("[A-Za-z0-9_-]{1,32}")), name_));
    named(behavior_, tr("Behavior"), tr("What will drive the robot; you can change it until it starts"));
    for (QComboBox* box : {class_, behavior_})
        box->setSizeAdjustPolicy(QComboBox::AdjustToContents);
    spawn_->setProperty("role", "primary");
    room_ = mutedLabel({}, this);
    for (QWidget* control : std::initializer_list<QWidget*>{class_, name_, behavior_})
        control->setMinimumHeight(minimum_target);
    auto* close = named(new QToolButton(this), tr("Close"), tr("Close (Esc)"));
    close->setIcon(icon(QStringLiteral("clear")));
    makeFlat(close);
    auto* head = laidOut(new QHBoxLayout, -1, {title_, close});
    head->setStretchFactor(title_, 1);
    auto* form = new QFormLayout;
    form->addRow(tr("Robot"), class_);
    form->addRow(tr("Name"), name_);
    form->addRow(tr("Behavior"), behavior_);
    auto* column = laidOut(new QVBoxLayout(this), {gap::medium, gap::small, gap::medium, gap::medium}, gap::small);
    column->addLayout(head);
    column->addLayout(form);
    auto* foot = laidOut(new QHBoxLayout, gap::small, {room_, spawn_});
    foot->setStretchFactor(room_, 1);
    column->addLayout(foot);
    setRoom(0, std::numeric_limits<int>::max());
    hide();
    over->installEventFilter(this);
    connect(close, &QToolButton::clicked, this, &QWidget::hide);
    connect(spawn_, &QPushButton::clicked, this, &SpawnCard::spawn);
    connect(class_, &QComboBox::currentIndexChanged, this, &SpawnCard::listBehaviors);
    connect(name_, &QLineEdit::textChanged, this, [this] { spawn_->setEnabled(ready()); });
    connect(class_, &QComboBox::activated, this, &SpawnCard::tellEdit);
    connect(behavior_, &QComboBox::activated, this, &SpawnCard::tellEdit);
    connect(name_, &QLineEdit::textEdited, this, &SpawnCard::tellEdit);
}

void SpawnCard::setRobots(const std::vector<agent::RobotDescription>& robots) {
    const QString chosen = class_->currentData().toString();
    const QSignalBlocker quiet(class_);
    robots_ = robots;
    class_->clear();
    for (const auto& robot : robots_)
        class_->addItem(QString::fromStdString(robot.name), QString::fromStdString(robot.class_name));
    class_->setCurrentIndex(std::max(0, class_->findData(chosen)));
    listBehaviors();
}

void SpawnCard::setRoom(int present, int most) {
    full_ = present >= most;
    const bool limited = most < std::numeric_limits<int>::max();
    room_->setText(limited && !full_ ? tr("Robot %1 of %2").arg(present + 1).arg(most) : QString());
    spawn_->setText(full_ ? tr("Limit reached: %1 robots").arg(most) : tr("Spawn"));
    spawn_->setToolTip(full_ ? tr("Remove a robot; then another one can be spawned")
                             : tr("Spawns the robot here (Return)"));
    spawn_->setEnabled(ready());
    for (QWidget* control : std::initializer_list<QWidget*>{class_, name_, behavior_})
        control->setEnabled(!full_);
}

void SpawnCard::listBehaviors() {
    behavior_->clear();
    const int row = class_->currentIndex();
    if (row >= 0 && row < static_cast<int>(robots_.size()))
        for (const auto& behavior : robots_[static_cast<std::size_t>(row)].behaviors) {
            behavior_->addItem(QString::fromStdString(behavior.name), QString::fromStdString(behavior.id));
            behavior_->setItemData(behavior_->count() - 1, QString::fromStdString(behavior.help), Qt::ToolTipRole);
        }
    behavior_->addItem(tr("None"), QString());
    preferBehavior(preferred_behavior_);
    if (isVisible()) { // Longer names need a wider card.
        takeNeededSize();
        place(pos());
    }
}

void SpawnCard::takeNeededSize() {
    layout()->activate(); // Else it knows the old names only.
    adjustSize();
}

void SpawnCard::place(const QPoint& corner) {
    const QSize room = parentWidget()->size() - size();
    move(std::clamp(corner.x(), 0, std::max(0, room.width())), std::clamp(corner.y(), 0, std::max(0, room.height())));
}

void SpawnCard::chooseClass(const QString& class_name) {
    if (const int row = class_->findData(class_name); row >= 0)
        class_->setCurrentIndex(row);
}

void SpawnCard::preferBehavior(const QString& id) {
    preferred_behavior_ = id;
    if (const int row = id.isEmpty() ? -1 : behavior_->findData(id); row >= 0)
        behavior_->setCurrentIndex(row);
}

void SpawnCard::openFor(int start_pose, const QString& pose_name, const QString& robot_name, const QPoint& at) {
    start_pose_ = start_pose;
    title_->setText(tr("Spawn at %1").arg(pose_name));
    name_->setText(robot_name);
    takeNeededSize();
    QPoint corner = parentWidget()->mapFromGlobal(at);
    // Opens on the other side instead of covering the pose, where the second click of a double-click must arrive.
    if (corner.x() > parentWidget()->width() - width())
        corner.rx() -= width() + 2 * pose_gap_px;
    told_ = choice();
    place(corner);
    show();
    raise();
    if (full_)
        setFocus(); // A disabled button takes no focus, and Escape must reach the card.
    else
        spawn_->setFocus();
}

SpawnChoice SpawnCard::lastChoice(int start_pose, const QString& robot_name) const {
    return {start_pose, class_->currentData().toString(), robot_name, behavior_->currentData().toString()};
}

void SpawnCard::tellEdit() {
    const SpawnChoice before = std::exchange(told_, choice());
    if (before != told_)
        emit choiceEdited(before, told_);
}

void SpawnCard::setChoice(const SpawnChoice& choice) {
    chooseClass(choice.class_name);
    if (const int row = behavior_->findData(choice.behavior_id); row >= 0)
        behavior_->setCurrentIndex(row);
    if (isVisible())
        name_->setText(choice.robot_name);
    told_ = this->choice();
}

void SpawnCard::spawn() {
    if (!ready())
        return;
    hide();
    emit spawnRequested(choice());
}

void SpawnCard::keyPressEvent(QKeyEvent* event) {
    if (event->key() == Qt::Key_Escape) {
        hide();
    } else if (event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter) {
        spawn();
    } else {
        QFrame::keyPressEvent(event);
    }
}

void SpawnCard::hideEvent(QHideEvent* event) {
    if (const QWidget* const focus = QApplication::focusWidget(); focus == this || isAncestorOf(focus))
        parentWidget()->setFocus();
    QFrame::hideEvent(event);
}

bool SpawnCard::eventFilter(QObject* watched, QEvent* event) {
    // Qt sends a double-click event instead of the second press.
    const bool spawns_elsewhere =
        event->type() == QEvent::KeyPress && static_cast<QKeyEvent*>(event)->key() == Qt::Key_Return;
    if (event->type() == QEvent::MouseButtonPress || event->type() == QEvent::MouseButtonDblClick ||
        event->type() == QEvent::Wheel || spawns_elsewhere)
        hide();
    return QFrame::eventFilter(watched, event);
}

} // namespace usar::widgets
