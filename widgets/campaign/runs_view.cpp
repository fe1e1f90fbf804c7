#include "widgets/campaign/runs_view.h"

#include <QHeaderView>
#include <QShortcut>
#include <QStyledItemDelegate>

#include "widgets/style/theme.h"
#include "widgets/style/tool_button.h"

namespace usar::widgets {

namespace {

/// Keeps the texts of neighboring columns apart, of which one may end and the other begin at the same line.
class RunCell : public QStyledItemDelegate {
public:
    using QStyledItemDelegate::QStyledItemDelegate;

protected:
    void initStyleOption(QStyleOptionViewItem* option, const QModelIndex& index) const override {
        QStyledItemDelegate::initStyleOption(option, index);
        const bool at_right = option->displayAlignment.testFlag(Qt::AlignRight);
        option->text = at_right ? option->text + QStringLiteral("     ") : QStringLiteral("  ") + option->text;
    }
};

} // namespace

RunsView::RunsView(RunTable& table, QWidget* parent)
    : QWidget(parent)
    , table_(table)
    , filter_(new RunFilter(&table))
    , words_(makeSearchLine(tr("Filter runs"),
                            tr("Shows the runs with these words in number, variant, mission, seed, outcome or reason"),
                            this)) {
    named(only_failures_, tr("Only runs that are not done"), tr("Hides the runs that were done"));
    only_failures_->setMinimumHeight(minimum_target);
    named(view_, tr("Runs of the campaign"), {});
    view_->setModel(filter_);
    view_->setItemDelegate(new RunCell(view_));
    view_->setSortingEnabled(true);
    view_->sortByColumn(RunTable::Number, Qt::AscendingOrder);
    view_->setSelectionBehavior(QAbstractItemView::SelectRows);
    view_->setSelectionMode(QAbstractItemView::SingleSelection);
    view_->setEditTriggers(QAbstractItemView::NoEditTriggers);
    view_->setTabKeyNavigation(false);
    view_->setShowGrid(false);
    view_->setWordWrap(false);
    view_->setContextMenuPolicy(Qt::CustomContextMenu);
    view_->verticalHeader()->hide();
    view_->verticalHeader()->setDefaultSectionSize(minimum_target);
    view_->horizontalHeader()->setStretchLastSection(true);
    view_->horizontalHeader()->setHighlightSections(false);
    view_->horizontalHeader()->setResizeContentsPrecision(
        50); // Enough rows to know the widths; there may be thousands.
    view_->horizontalHeader()->setMinimumSectionSize(72);
    view_->horizontalHeader()->setStyleSheet( // As far from the edges as the cells' texts, with room for the arrow.
        QStringLiteral("QHeaderView::section { padding: %1px %2px; padding-right: 20px; }")
            .arg(gap::tiny)
            .arg(gap::small));
    view_->setMinimumHeight(3 * minimum_target);
    nothing_ = new EmptyState(view_, tr("No runs yet"),
                              tr("Each run gets a row here as it ends. Set a campaign up and run it, or open the "
                                 "results of an earlier one."));
    auto* const head = laidOut(new QHBoxLayout, gap::small, {words_, only_failures_, count_});
    head->setStretchFactor(words_, 1);
    auto* const column = laidOut(new QVBoxLayout(this), {gap::small, gap::tiny, gap::small, gap::small}, gap::tiny);
    column->addLayout(head);
    column->addWidget(view_, 1);
    connect(words_, &QLineEdit::textChanged, filter_, &RunFilter::setWords);
    connect(only_failures_, &QCheckBox::toggled, filter_, &RunFilter::setOnlyFailures);
    const auto choose = [this] {
        if (const auto number = currentRun())
            emit runChosen(*number);
    };
    connect(view_, &QTableView::doubleClicked, this, choose);
    for (const int key : {Qt::Key_Return, Qt::Key_Enter})
        connect(new QShortcut(QKeySequence(key), view_, nullptr, nullptr, Qt::WidgetShortcut), &QShortcut::activated,
                this, choose);
    connect(view_, &QWidget::customContextMenuRequested, this, [this](const QPoint& at) { popUpRowMenu(view_, at); });
    connect(view_->selectionModel(), &QItemSelectionModel::currentRowChanged, this, &RunsView::currentChanged);
    for (const auto changed : {&QAbstractItemModel::rowsInserted, &QAbstractItemModel::rowsRemoved})
        connect(filter_, changed, this, &RunsView::showCount);
    connect(filter_, &QAbstractItemModel::modelReset, this, [this] {
        view_->resizeColumnsToContents();
        showCount();
    });
    showCount();
}

std::optional<int> RunsView::currentRun() const {
    const QModelIndex index = filter_->mapToSource(view_->currentIndex());
    return index.isValid() ? std::optional(table_.row(index.row()).number) : std::nullopt;
}

void RunsView::setActions(QAction* fly, QAction* fly_pair, QAction* copy) {
    view_->addActions({fly, fly_pair, copy});
}

void RunsView::showCount() {
    const int shown = filter_->rowCount(), all = table_.rowCount();
    if (all > 0 && nothing_->isVisibleTo(this))
        view_->resizeColumnsToContents(); // The first rows say how wide the columns must be.
    nothing_->setVisible(all == 0);
    count_->setText(shown == all ? QString() : tr("%1 of %2").arg(shown).arg(all));
}

} // namespace usar::widgets
