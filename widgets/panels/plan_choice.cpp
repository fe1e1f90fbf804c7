#include "widgets/panels/plan_choice.h"

#include <QFileInfo>
#include <QSignalBlocker>

#include "widgets/style/form_parts.h"
#include "widgets/style/icons.h"
#include "widgets/style/theme.h"

namespace usar::widgets {

PlanChoice::PlanChoice(QWidget* parent) : QWidget(parent) {
    laidOut(new QHBoxLayout(this), {}, gap::tiny, {box_})->setStretchFactor(box_, 1);
    box_->setAccessibleName(tr("Plan"));
    box_->setMinimumHeight(minimum_target);
    box_->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    box_->setMinimumContentsLength(12);
    const QToolButton* open = addButton("open", tr("Open plan"), tr("Use a plan of your own (.lap)"));
    const QToolButton* edit = addButton("edit", tr("Edit plan"), tr("View and edit the chosen plan"));
    connect(open, &QToolButton::clicked, this, &PlanChoice::openRequested);
    connect(edit, &QToolButton::clicked, this, &PlanChoice::editRequested);
    connect(box_, &QComboBox::currentIndexChanged, this,
            [this](int index) { box_->setToolTip(box_->itemData(index, Qt::ToolTipRole).toString()); });
    connect(box_, &QComboBox::activated, this, [this] { emit chosen(path()); });
    hide();
}

QToolButton* PlanChoice::addButton(const QString& icon_name, const QString& text, const QString& help) {
    auto* button = named(new QToolButton, text, help);
    button->setIcon(icon(icon_name));
    button->setMinimumSize(minimum_target, minimum_target);
    layout()->addWidget(button);
    return button;
}

void PlanChoice::setBehavior(const std::string& behavior_id, const QString& plan_name) {
    behavior_id_ = plan_name.isEmpty() ? std::string() : behavior_id;
    setVisible(!empty());
    const QSignalBlocker silent(box_);
    box_->clear();
    if (empty())
        return;
    box_->addItem(tr("%1 (comes with the robot)").arg(plan_name), QString());
    box_->setItemData(0, tr("The plan that comes with the robot decides"), Qt::ToolTipRole);
    for (const QString& path : paths_[behavior_id_])
        addFile(path);
    box_->setToolTip(box_->itemData(0, Qt::ToolTipRole).toString());
}

void PlanChoice::choose(const QString& path) {
    if (empty())
        return;
    const QSignalBlocker silent(box_);
    if (box_->findData(path) < 0) {
        paths_[behavior_id_] += path;
        addFile(path);
    }
    box_->setCurrentIndex(box_->findData(path));
    box_->setToolTip(box_->currentData(Qt::ToolTipRole).toString());
}

void PlanChoice::addFile(const QString& path) {
    box_->addItem(QFileInfo(path).fileName(), path);
    box_->setItemData(box_->count() - 1, path, Qt::ToolTipRole);
}

} // namespace usar::widgets
