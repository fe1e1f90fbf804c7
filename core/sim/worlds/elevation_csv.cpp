#include "core/sim/worlds/elevation_csv.h"

#include <cmath>
#include <fstream>
#include <string>
#include <string_view>

#include "core/base/numbers.h"

namespace usar::sim {

namespace {

bool appendRow(std::string_view line, std::vector<double>& heights_m) {
    for (;;) {
        const std::size_t comma = line.find(',');
        const auto height_m = readNumber(line.substr(0, comma));
        if (!height_m || !std::isfinite(*height_m))
            return false;
        heights_m.push_back(*height_m);
        if (comma == std::string_view::npos)
            return true;
        line.remove_prefix(comma + 1);
    }
}

} // namespace

Result<ElevationTable> readElevationCsv(const std::filesystem::path& file) {
    std::ifstream in(file, std::ios::binary);
    if (!in)
        return failure("the heights cannot be opened", file.string(), "Check the file's name and its permissions");
    ElevationTable table;
    std::string line;
    while (std::getline(in, line)) {
        const std::string where = file.string() + ":" + std::to_string(table.rows + 1);
        const std::size_t before = table.heights_m.size();
        if (!appendRow(line, table.heights_m))
            return failure("one of the values is not a height", where, "Give numbers with commas between them");
        const std::size_t columns = table.heights_m.size() - before;
        if (table.rows > 0 && columns != table.columns)
            return failure("the line has " + std::to_string(columns) + " heights, the first one " +
                               std::to_string(table.columns),
                           where, "Give every line the same number of heights");
        table.columns = columns;
        ++table.rows;
    }
    if (table.rows < 4 || table.columns < 4)
        return failure("there are fewer than 4 x 4 heights", file.string(), "Check that the file is complete");
    return table;
}

} // namespace usar::sim
