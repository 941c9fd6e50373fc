#include "tools/bench/table_files.h"

#include <iostream>

#include "common/output_file.h"
#include "tools/usage.h"

namespace eikonal::bench {

void addTableFiles(CLI::App& command, TableFiles& files, const std::string& chart) {
    command.add_option("-o,--output", files.csv, "CSV to write [stdout]")->type_name("FILE.csv");
    command.add_option("--svg", files.svg, chart)->type_name("FILE.svg");
}

void requireWritable(const TableFiles& files) {
    for (const std::string& file : {files.csv, files.svg}) {
        if (!file.empty()) eikonal::requireWritable(file);
    }
    if (!files.svg.empty()) requireApart("--svg", files.svg, {files.csv});
}

void write(const TableFiles& files, const std::string& csv, const std::string& svg) {
    if (files.csv.empty()) {
        std::cout << csv;
    } else {
        writeFile(files.csv, csv);
    }
    if (!files.svg.empty()) writeFile(files.svg, svg);
}

} // namespace eikonal::bench
