robot broken { body }
