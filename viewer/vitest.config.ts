import { defineConfig } from 'vitest/config';

export default defineConfig({
  test: {
    // Whole pages share the processors with the browser that shows them: one file after the other.
    fileParallelism: false,
    testTimeout: 300_000,
    hookTimeout: 300_000,
  },
});
