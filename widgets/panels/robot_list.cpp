#include "widgets/panels/robot_list.h"

#include <QAction>
#include <QMenu>
#include <QScopedValueRollback>
#include <QVBoxLayout>

#include "widgets/panels/robot_delegate.h"
#include "widgets/style/empty_state.h"

namespace usar::widgets {

RobotList::RobotList(QWidget* parent) : QWidget(parent) {
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->addWidget(view_);
    view_->setModel(model_);
    view_->setItemDelegate(new RobotDelegate(view_));
    view_->setUniformItemSizes(true);
    view_->setMouseTracking(true);
    view_->setFrameShape(QFrame::NoFrame);
    view_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    view_->setEditTriggers(QAbstractItemView::NoEditTriggers);
    view_->setContextMenuPolicy(Qt::CustomContextMenu);
    view_->setAccessibleName(tr("Robots"));
    setFocusProxy(view_);
    auto* remove = new QAction(tr("Remove this robot"), view_);
    remove->setShortcut(QKeySequence::Delete);
    remove->setShortcutContext(Qt::WidgetShortcut);
    view_->addAction(remove);
    connect(remove, &QAction::triggered, this, &RobotList::requestRemoval);
    connect(view_, &QWidget::customContextMenuRequested, this, &RobotList::showMenu);
    connect(view_->selectionModel(), &QItemSelectionModel::currentChanged, this, [this](const QModelIndex& current) {
        if (!quiet_ && current.isValid())
            emit robotSelected(model_->row(current.row()).id);
    });
    empty_state_ = new EmptyState(view_);
    empty_state_->setText(tr("No robot yet"), tr("Double-click a start pose on the map to spawn one."));
}

void RobotList::setRobots(const std::vector<RobotRow>& robots) {
    const std::optional<int> selected = selectedRobot();
    {
        const QScopedValueRollback quiet(quiet_, true);
        model_->setRobots(robots);
    }
    if (selected)
        selectRobot(*selected);
    updateEmptyState();
}

void RobotList::updateRobot(const RobotRow& robot) {
    const QScopedValueRollback quiet(quiet_, true);
    const std::optional<int> selected = selectedRobot();
    model_->updateRobot(robot);
    if (selected && selectedRobot() != selected)
        selectRobot(*selected);
    updateEmptyState();
}

void RobotList::removeRobot(int id) {
    model_->removeRobot(id);
    updateEmptyState();
}

void RobotList::selectRobot(int id) {
    const QScopedValueRollback quiet(quiet_, true);
    const std::optional<int> at = model_->indexOf(id);
    view_->setCurrentIndex(at ? model_->index(*at) : QModelIndex());
}

std::optional<int> RobotList::selectedRobot() const {
    const QModelIndex current = view_->currentIndex();
    return current.isValid() ? std::optional(model_->row(current.row()).id) : std::nullopt;
}

void RobotList::showMenu(const QPoint& at) {
    if (!view_->indexAt(at).isValid())
        return;
    auto* menu = new QMenu(this);
    menu->setAttribute(Qt::WA_DeleteOnClose);
    menu->addActions(view_->actions());
    menu->popup(view_->viewport()->mapToGlobal(at));
}

void RobotList::requestRemoval() {
    if (const std::optional<int> id = selectedRobot())
        emit removeRequested(*id);
}

void RobotList::updateEmptyState() {
    empty_state_->setVisible(model_->rowCount() == 0);
}

} // namespace usar::widgets
