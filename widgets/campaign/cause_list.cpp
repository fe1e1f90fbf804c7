#include "widgets/campaign/cause_list.h"

#include <algorithm>

#include <QBoxLayout>
#include <QHeaderView>
#include <QSet>

#include "widgets/style/empty_state.h"
#include "widgets/style/theme.h"

namespace usar::widgets {

namespace {

constexpr std::size_t most_runs = 200; // Nobody reads more of them, and each is an item.

/// A row that says how many of the runs that follow each other ended at the place of the first one.
QTreeWidgetItem* addPlace(QTreeWidgetItem* cause, const std::vector<CausedRun>& runs, const QString& place) {
    const auto count = std::ranges::count(runs, place, &CausedRun::place);
    auto* const item = new QTreeWidgetItem(
        cause, {place.isEmpty() ? CauseList::tr("at a place that is not known") : place, QString::number(count)});
    item->setTextAlignment(1, Qt::AlignRight | Qt::AlignVCenter);
    item->setExpanded(true);
    return item;
}

void addRuns(QTreeWidgetItem* cause, const std::vector<CausedRun>& runs) {
    const bool any_place = std::ranges::any_of(runs, [](const CausedRun& run) { return !run.place.isEmpty(); });
    QTreeWidgetItem* parent = cause;
    for (std::size_t i = 0; i < std::min(runs.size(), most_runs); ++i) {
        if (any_place && (i == 0 || runs[i].place != runs[i - 1].place))
            parent = addPlace(cause, runs, runs[i].place);
        auto* const item = new QTreeWidgetItem(parent, {runs[i].name + ": " + runs[i].reason});
        item->setToolTip(0, runs[i].reason);
        item->setData(0, Qt::UserRole, runs[i].number);
        item->setFirstColumnSpanned(true);
    }
}

} // namespace

CauseList::CauseList(QWidget* parent) : QWidget(parent) {
    named(tree_, tr("Why runs were not done"), {});
    tree_->setHeaderLabels({tr("Why"), tr("Runs")});
    tree_->setUniformRowHeights(true);
    tree_->header()->setStretchLastSection(false);
    tree_->header()->setSectionResizeMode(0, QHeaderView::Stretch);
    tree_->header()->setSectionResizeMode(1, QHeaderView::ResizeToContents);
    tree_->headerItem()->setTextAlignment(1, Qt::AlignRight);
    nothing_ = new EmptyState(tree_);
    laidOut(new QVBoxLayout(this), {gap::small, gap::tiny, gap::small, gap::small}, 0, {tree_});
    connect(tree_, &QTreeWidget::itemActivated, this, &CauseList::choose);
    setCauses({}, false);
}

void CauseList::setCauses(const std::vector<CauseRow>& causes, bool any_runs) {
    nothing_->setVisible(causes.empty());
    if (any_runs)
        nothing_->setText(tr("Every run was done"), tr("Runs that fail, crash or take too long are grouped here."));
    else
        nothing_->setText(tr("No runs yet"), tr("Runs that are not done are grouped here by what ended them."));
    if (causes == causes_)
        return;
    QSet<QString> open;
    for (int i = 0; i < tree_->topLevelItemCount(); ++i)
        if (tree_->topLevelItem(i)->isExpanded())
            open << tree_->topLevelItem(i)->text(0);
    causes_ = causes;
    tree_->clear();
    for (const CauseRow& cause : causes) {
        auto* const item = new QTreeWidgetItem(tree_, {cause.reason, QString::number(cause.runs.size())});
        item->setToolTip(0, cause.reason + '\n' + cause.variants);
        item->setTextAlignment(1, Qt::AlignRight | Qt::AlignVCenter);
        item->setSizeHint(0, QSize(0, minimum_target));
        (new QTreeWidgetItem(item, {cause.variants}))->setFirstColumnSpanned(true);
        addRuns(item, cause.runs);
        item->setExpanded(open.contains(cause.reason));
    }
}

void CauseList::choose(const QTreeWidgetItem* item) {
    if (const QVariant number = item->data(0, Qt::UserRole); number.isValid())
        emit runChosen(number.toInt());
}

} // namespace usar::widgets
