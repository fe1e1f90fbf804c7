// Compares runs: the figures of two or more finished missions side by side, and their pictures.
#pragma once

#include <memory>
#include <vector>

#include <QBoxLayout>
#include <QDialog>
#include <QImage>
#include <QLabel>
#include <QPushButton>
#include <QTableWidget>
#include <QThreadPool>

#include "core/mapping/raster_export.h"
#include "widgets/models/run_comparison.h"
#include "widgets/style/empty_state.h"

namespace usar::widgets {

/// One column for each run, in the order in which they were added; differences are from the first. It is not modal, and
/// its files are read in a pool. GUI thread.
class CompareDialog : public QDialog {
    Q_OBJECT
public:
    explicit CompareDialog(QWidget* parent = nullptr);

    /// Adds the run with this summary (.json); one that is shown already is read again. A file that is none is named
    /// with what to do instead. `title`: what the run is shown as; empty: the name of its file.
    void add(const QString& summary, const QString& title = {});
    /// Takes all runs out of the table.
    void clear();
    /// Folder in which files are chosen until a run was added.
    void setFolder(const QString& folder) { folder_ = folder; }
    const std::vector<RunFigures>& runs() const { return runs_; }
    /// What is wrong with the files that were chosen last, a line for each; empty: nothing.
    QString trouble() const { return trouble_->text(); }
    QSize sizeHint() const override { return {760, 670}; }

private:
    struct Read {
        Result<RunFigures> run;
        QImage picture;            ///< null: there is none
        mapping::Raster heights{}; ///< It is empty if there are none.
    };
    /// How the maps of the first two runs differ.
    struct MapDifference {
        QImage picture{}; ///< It is null if they cannot be compared.
        QString words{};
        std::shared_ptr<const mapping::Raster> first{}; ///< These two maps were compared.
        std::shared_ptr<const mapping::Raster> second{};
    };
    void lay();
    void choose();
    void take(const Read& read);
    void removeChosen();
    void showRuns();
    void showRow(int row, const ComparedRow& figures);
    void showPictures();
    void addPicture(const QImage& picture, const QString& instead, const QString& name, const QString& tip);
    /// Compares the maps of the first two runs in the pool, if these are others than before.
    void compareMaps();

    std::vector<RunFigures> runs_;
    std::vector<QImage> pictures_;                             ///< of the runs, in their order; small
    std::vector<std::shared_ptr<const mapping::Raster>> maps_; ///< They are in the order of the runs.
    MapDifference difference_;
    QString folder_;
    QLabel* hint_ = new QLabel(this);
    QLabel* trouble_ = new QLabel(this);
    QLabel* difference_text_ = new QLabel(this);
    QTableWidget* table_ = new QTableWidget(this);
    QWidget* gallery_ = new QWidget(this);
    EmptyState* nothing_ = nullptr; ///< over the table, as long as there is no run
    QPushButton* add_ = new QPushButton(tr("Add runs…"), this);
    QPushButton* remove_ = new QPushButton(tr("Remove run"), this);
    QPushButton* close_ = new QPushButton(tr("Close"), this);
    QThreadPool pool_; ///< its destructor waits
};

/// Shows the dialog beside `parent`, or raises the open one, and returns at once. `path`: a summary to add, or the
/// folder in which to choose. `title`: what the run is shown as; empty: the name of its file.
void compareRuns(QWidget* parent, const QString& path, const QString& title = {});

} // namespace usar::widgets
