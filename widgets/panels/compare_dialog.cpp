#include "widgets/panels/compare_dialog.h"

#include <algorithm>

#include <QFileInfo>
#include <QHeaderView>
#include <QImageReader>
#include <QScrollArea>

#include "widgets/models/height_difference.h"
#include "widgets/panels/dialogs.h"
#include "widgets/style/form_parts.h"
#include "widgets/style/theme.h"

namespace usar::widgets {

namespace {

constexpr QSize picture_px{300, 170};

QImage pictureOf(const QString& path) {
    const QImage picture = path.isEmpty() ? QImage() : QImageReader(path).read();
    return picture.isNull() ? picture : picture.scaled(picture_px, Qt::KeepAspectRatio, Qt::SmoothTransformation);
}

} // namespace

CompareDialog::CompareDialog(QWidget* parent) : QDialog(parent) {
    setWindowTitle(tr("Compare runs"));
    setAccessibleName(windowTitle());
    named(add_, tr("Add runs"), tr("Chooses the summaries (.json) that missions left with their results"));
    named(remove_, tr("Remove run"), tr("Takes the run of the chosen column out of the table; its files stay"));
    hint_->setText(tr("Add two runs or more. Differences are from the first run; ✓ marks the better figure."));
    hint_->setWordWrap(true);
    setRole(hint_, "muted");
    trouble_->setWordWrap(true);
    trouble_->setAccessibleName(tr("File that cannot be compared"));
    setRole(trouble_, "caution");
    trouble_->hide();
    difference_text_->setWordWrap(true);
    difference_text_->setAccessibleName(tr("Difference of the maps"));
    setRole(difference_text_, "muted");
    difference_text_->hide();
    pool_.setMaxThreadCount(1); // The runs keep the order in which they were added.
    lay();
    resize(sizeHint()); // Qt would make it at most two thirds as wide as the screen.
    connect(add_, &QPushButton::clicked, this, &CompareDialog::choose);
    connect(remove_, &QPushButton::clicked, this, &CompareDialog::removeChosen);
    connect(close_, &QPushButton::clicked, this, &QWidget::close);
    connect(table_, &QTableWidget::itemSelectionChanged, this,
            [this] { remove_->setEnabled(!table_->selectedItems().isEmpty()); });
    showRuns();
}

void CompareDialog::lay() {
    table_->setAccessibleName(tr("Figures of the runs"));
    table_->setEditTriggers(QAbstractItemView::NoEditTriggers);
    table_->setSelectionBehavior(QAbstractItemView::SelectColumns);
    table_->setSelectionMode(QAbstractItemView::SingleSelection);
    table_->setTabKeyNavigation(false);
    table_->horizontalHeader()->setSectionResizeMode(QHeaderView::Stretch);
    table_->horizontalHeader()->setMinimumSectionSize(150);
    table_->verticalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
    auto* const scroll = new QScrollArea(this);
    scroll->setWidgetResizable(true);
    scroll->setFrameShape(QFrame::NoFrame);
    scroll->setWidget(gallery_);
    scroll->setFixedHeight(picture_px.height() + gap::large);
    table_->setMinimumHeight(180);
    nothing_ = new EmptyState(table_, tr("No runs yet"),
                              tr("Press Add runs and choose the summaries (.json) that missions leave with their "
                                 "results. The card at a mission's end compares that mission, too."));
    laidOut(new QHBoxLayout(gallery_), {}, gap::medium);
    auto* const buttons = laidOut(new QHBoxLayout, gap::small, {add_, remove_});
    buttons->addStretch(1);
    buttons->addWidget(close_);
    for (QPushButton* const button : {add_, remove_, close_})
        button->setAutoDefault(false); // Return in the table must not open a file dialog.
    auto* const column =
        laidOut(new QVBoxLayout(this), gap::small, {hint_, trouble_, table_, scroll, difference_text_});
    column->setStretch(2, 1);
    column->addLayout(buttons);
}

void CompareDialog::choose() {
    const QString begin = runs_.empty() ? folder_ : QFileInfo(runs_.back().path).path();
    trouble_->clear();
    trouble_->hide();
    askForFiles(this, tr("Add runs"), begin, tr("Summaries of runs (*.json)"),
                [this](const QString& path) { add(path); });
}

void CompareDialog::add(const QString& summary, const QString& title) {
    pool_.start([this, summary, title] {
        Read read{readRun(summary), {}, {}};
        if (read.run) {
            read.run->title = title;
            read.picture = pictureOf(read.run->picture);
            read.heights = readHeights(summary);
        }
        QMetaObject::invokeMethod(
            this, [this, read] { take(read); }, Qt::QueuedConnection);
    });
}

void CompareDialog::clear() {
    runs_.clear();
    pictures_.clear();
    maps_.clear();
    trouble_->clear();
    trouble_->hide();
    showRuns();
    compareMaps();
}

void CompareDialog::take(const Read& read) {
    if (!read.run) {
        const QString text = QString::fromStdString(read.run.error().text());
        trouble_->setText(trouble_->text().isEmpty() ? text : trouble_->text() + u'\n' + text);
        return trouble_->show();
    }
    const auto same = std::ranges::find(runs_, read.run->path, &RunFigures::path);
    const auto at = same - runs_.begin();
    auto heights = std::make_shared<const mapping::Raster>(read.heights);
    if (same == runs_.end()) {
        runs_.push_back(*read.run);
        pictures_.push_back(read.picture);
        maps_.push_back(std::move(heights));
    } else {
        *same = *read.run;
        pictures_[static_cast<std::size_t>(at)] = read.picture;
        maps_[static_cast<std::size_t>(at)] = std::move(heights);
    }
    showRuns();
    compareMaps();
}

void CompareDialog::removeChosen() {
    const int column = table_->currentColumn();
    if (column < 0 || column >= static_cast<int>(runs_.size()))
        return;
    runs_.erase(runs_.begin() + column);
    pictures_.erase(pictures_.begin() + column);
    maps_.erase(maps_.begin() + column);
    showRuns();
    compareMaps();
}

void CompareDialog::showRuns() {
    if (maps_.size() < 2 || difference_.first != maps_[0] || difference_.second != maps_[1])
        difference_ = {}; // It is of other runs; the pool answers later for these.
    const std::vector<ComparedRow> rows = compared(runs_);
    table_->clear();
    table_->setColumnCount(static_cast<int>(runs_.size()));
    table_->setRowCount(static_cast<int>(rows.size()));
    for (std::size_t column = 0; column < runs_.size(); ++column) {
        auto* const head = new QTableWidgetItem(titleOf(runs_[column]));
        head->setToolTip(runs_[column].path);
        table_->setHorizontalHeaderItem(static_cast<int>(column), head);
    }
    for (std::size_t row = 0; row < rows.size(); ++row)
        showRow(static_cast<int>(row), rows[row]);
    remove_->setEnabled(false);
    nothing_->setVisible(runs_.empty());
    showPictures();
}

void CompareDialog::showRow(int row, const ComparedRow& figures) {
    auto* const head = new QTableWidgetItem(figures.name);
    head->setToolTip(figures.help);
    table_->setVerticalHeaderItem(row, head);
    for (std::size_t column = 0; column < figures.cells.size(); ++column) {
        const ComparedCell& cell = figures.cells[column];
        const QString difference =
            cell.difference.isEmpty() ? QString() : QStringLiteral("  (%1)").arg(cell.difference);
        const QString mark = cell.better ? QStringLiteral("✓ ") : QString();
        auto* const item = new QTableWidgetItem(mark + cell.value + difference);
        item->setToolTip(figures.help);
        item->setData(Qt::AccessibleTextRole,
                      figures.name + u' ' + cell.value + difference + (cell.better ? tr(", better") : QString()));
        if (cell.better)
            item->setFont(themeFont(FontRole::Body, QFont::DemiBold));
        table_->setItem(row, static_cast<int>(column), item);
    }
}

void CompareDialog::showPictures() {
    qDeleteAll(gallery_->findChildren<QWidget*>(Qt::FindDirectChildrenOnly));
    const bool any = std::ranges::any_of(pictures_, [](const QImage& picture) { return !picture.isNull(); });
    gallery_->parentWidget()->parentWidget()->setVisible(any);
    for (std::size_t i = 0; i < pictures_.size(); ++i) {
        const QString name = titleOf(runs_[i]).section(u'\n', -1);
        addPicture(pictures_[i], tr("%1 has no picture").arg(name), tr("Picture of %1").arg(name), name);
        if (i == 1 && !difference_.picture.isNull())
            addPicture(difference_.picture, {}, tr("Difference of the first two maps"), difference_.words);
    }
    difference_text_->setText(difference_.words);
    difference_text_->setVisible(any && !difference_.words.isEmpty());
}

void CompareDialog::addPicture(const QImage& picture, const QString& instead, const QString& name, const QString& tip) {
    auto* const label = named(new QLabel(gallery_), name, tip);
    label->setAlignment(Qt::AlignCenter);
    if (picture.isNull())
        label->setText(instead);
    else
        label->setPixmap(QPixmap::fromImage(picture));
    gallery_->layout()->addWidget(label);
}

void CompareDialog::compareMaps() {
    if (maps_.size() < 2 || maps_[0]->empty() || maps_[1]->empty()) {
        difference_ = {};
        return showPictures();
    }
    pool_.start([this, first = maps_[0], second = maps_[1]] {
        MapDifference found;
        found.first = first;
        found.second = second;
        if (const auto difference = mapping::differenceOf(*first, *second)) {
            const QImage picture = differencePicture(*difference, fullColorOf_m(*difference));
            found.picture = picture.scaled(picture_px, Qt::KeepAspectRatio);
            found.words = differenceText(*difference);
        }
        QMetaObject::invokeMethod(
            this,
            [this, found, first, second] {
                if (maps_.size() < 2 || maps_[0] != first || maps_[1] != second)
                    return; // Other runs are compared by now.
                difference_ = found;
                showPictures();
            },
            Qt::QueuedConnection);
    });
}

void compareRuns(QWidget* parent, const QString& path, const QString& title) {
    auto* dialog = parent->findChild<CompareDialog*>(QString(), Qt::FindDirectChildrenOnly);
    if (!dialog)
        dialog = new CompareDialog(parent);
    if (path.endsWith(QStringLiteral(".json")))
        dialog->add(path, title);
    else // The folder of the results, which the first mission makes.
        dialog->setFolder(path);
    showInFront(dialog);
}

} // namespace usar::widgets
