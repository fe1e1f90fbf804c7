// Makes a test of a moment of a flight: when, what is claimed, and its name.
#pragma once

#include <optional>
#include <vector>

#include <QDialog>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QPushButton>

#include "widgets/panels/quantity_box.h"
#include "widgets/style/empty_state.h"

namespace usar::widgets {

/// A claim that may be chosen.
struct TestOffer {
    QString text;
    std::optional<bool> held; ///< Whether it held in the flight; absent: the recording does not tell.
    bool operator==(const TestOffer&) const = default;
};

/// A part of a flight, in seconds since the robot appeared.
struct FlightSpan {
    double from_s = 0.0;
    double to_s = 0.0;
};

/// Tells the user's wishes by signals and writes nothing itself. Not modal; Escape closes it. GUI thread.
class TestDialog : public QDialog {
    Q_OBJECT
public:
    explicit TestDialog(QWidget* parent);

    /// Says that the recording is being read; nothing can be chosen until `setMoment`.
    void setReading(const QString& robot);
    /// A test of this moment can be made: it proposes ten seconds from there, within `known`. `caution`: a sentence on
    /// what the test cannot repeat, or empty.
    void setMoment(double at_s, const FlightSpan& known, const QString& name, const QString& caution);
    /// Lists these claims. The chosen one stays chosen if its text is among them, else the first is.
    void setOffers(const std::vector<TestOffer>& offers);
    void setFolder(const QString& folder);
    /// Says what went wrong, below the list; empty: nothing.
    void complain(const QString& text);

    FlightSpan span() const;
    QString name() const { return name_->text().trimmed(); }
    /// Index of the chosen offer; -1: none.
    int chosen() const { return list_->currentRow(); }

signals:
    /// Other claims are to be offered.
    void spanChanged();
    void folderRequested();
    /// The test is to be written.
    void makeRequested();

private:
    void lay();
    void refresh();

    QLabel* words_;
    QLineEdit* name_ = new QLineEdit(this);
    QuantityBox* from_ = new QuantityBox(this);
    QuantityBox* for_ = new QuantityBox(this);
    QListWidget* list_ = new QListWidget(this);
    QLabel* folder_;
    QPushButton* choose_folder_ = new QPushButton(tr("Change…"), this);
    QLabel* trouble_;
    QPushButton* make_ = new QPushButton(tr("Make test"), this);
    QPushButton* close_ = new QPushButton(tr("Close"), this);
    EmptyState* nothing_ = nullptr; ///< over the list, as long as there is no offer
    bool ready_ = false;
};

} // namespace usar::widgets
