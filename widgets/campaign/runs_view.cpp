#include "widgets/campaign/runs_view.h"

#include <algorithm>

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
    setUpTable();
    nothing_ = new EmptyState(view_);
    auto* const head = laidOut(new QHBoxLayout, gap::small, {words_, only_failures_, count_});
    head->setStretchFactor(words_, 1);
    auto* const column = laidOut(new QVBoxLayout(this), {gap::small, gap::tiny, gap::small, gap::small}, gap::tiny);
    column->addLayout(head);
    column->addWidget(view_, 1);
    wire();
    showCount();
}

void RunsView::setUpTable() {
    named(view_, tr("Runs of the campaign"), {});
    view_->setModel(filter_);
    view_->setItemDelegate(new RunCell(view_));
    view_->setSortingEnabled(true);
    view_->sortByColumn(RunTable::Number, Qt::AscendingOrder);
    view_->setSelectionBehavior(QAbstractItemView::SelectRows);
    view_->setSelectionMode(QAbstractItemView::ExtendedSelection);
    view_->setEditTriggers(QAbstractItemView::NoEditTriggers);
    view_->setTabKeyNavigation(false);
    view_->setShowGrid(false);
    view_->setWordWrap(false);
    view_->setTextElideMode(Qt::ElideMiddle); // Names of variants differ at their ends.
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
}

void RunsView::wire() {
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
    connect(view_, &QWidget::customContextMenuRequested, this, [this](const QPoint& at) {
        if (view_->indexAt(at).isValid())
            makeRowMenu()->popup(view_->viewport()->mapToGlobal(at));
    });
    connect(view_->selectionModel(), &QItemSelectionModel::currentRowChanged, this, &RunsView::currentChanged);
    connect(view_->selectionModel(), &QItemSelectionModel::selectionChanged, this, &RunsView::currentChanged);
    for (const auto changed : {&QAbstractItemModel::rowsInserted, &QAbstractItemModel::rowsRemoved})
        connect(filter_, changed, this, &RunsView::showCount);
    connect(&table_, &QAbstractItemModel::rowsInserted, this,
            [this](const QModelIndex&, int first, int last) { widenFor(first, last); });
    connect(filter_, &QAbstractItemModel::modelReset, this, [this] {
        variants_.clear();
        view_->resizeColumnsToContents();
        showCount();
    });
}

std::optional<int> RunsView::currentRun() const {
    const QModelIndex index = filter_->mapToSource(view_->currentIndex());
    return index.isValid() ? std::optional(table_.row(index.row()).number) : std::nullopt;
}

std::vector<int> RunsView::selectedRuns() const {
    std::vector<int> rows, numbers;
    for (const QModelIndex& index : view_->selectionModel()->selectedRows())
        rows.push_back(index.row());
    std::ranges::sort(rows);
    for (const int row : rows)
        numbers.push_back(table_.row(filter_->mapToSource(filter_->index(row, 0)).row()).number);
    return numbers;
}

QMenu* RunsView::makeRowMenu() {
    auto* const menu = new QMenu(view_);
    menu->setAttribute(Qt::WA_DeleteOnClose);
    menu->addActions(view_->actions());
    if (partners_.size() < 2 || selectedRuns().size() > 1)
        return menu; // The command compares with the only other one, or with the other that is selected.
    QMenu* const partners = menu->addMenu(tr("Compare on the seed with"));
    for (const RunPartner& partner : partners_)
        connect(partners->addAction(partner.variant), &QAction::triggered, this,
                [this, number = partner.number] { emit partnerChosen(number); });
    return menu;
}

void RunsView::setActions(QAction* fly, QAction* fly_pair, QAction* copy) {
    view_->addActions({fly, fly_pair, copy});
}

void RunsView::widenFor(int first_row, int last_row) {
    constexpr int most_px = 320; // A longer name loses its middle; the figures beside it are to be seen, too.
    for (int row = first_row; row <= last_row; ++row) {
        const QString& variant = table_.row(row).variant;
        if (variants_.contains(variant))
            continue;
        variants_.insert(variant);
        const int text_px = view_->fontMetrics().horizontalAdvance(QStringLiteral("  ") + variant) + 2 * gap::medium;
        view_->setColumnWidth(RunTable::Variant,
                              std::max(view_->columnWidth(RunTable::Variant), std::min(text_px, most_px)));
    }
}

void RunsView::showCount() {
    const int shown = filter_->rowCount(), all = table_.rowCount();
    if (all > 0 && !sized_) {
        view_->resizeColumnsToContents(); // The first rows say how wide the columns must be.
        widenFor(0, all - 1);
    }
    sized_ = all > 0;
    if (all == 0)
        nothing_->setText(tr("No runs yet"), tr("Each run gets a row here as it ends. Set a campaign up and run it, or "
                                                "open the results of an earlier one."));
    else if (words_->text().trimmed().isEmpty())
        nothing_->setText(tr("Every run was done"), tr("Runs that fail, crash or take too long are listed here."));
    else
        nothing_->setText(tr("No run has all of these words"),
                          tr("They are looked for in number, variant, mission, seed, outcome and reason."));
    nothing_->offerAction(all == 0); // A campaign that is opened would take the place of the one that is filtered.
    nothing_->setVisible(shown == 0);
    count_->setText(shown == all ? QString() : tr("%1 of %2").arg(shown).arg(all));
}

} // namespace usar::widgets
